// Forms to the display's program: own origin, JSON, the token of this page.
const token = document.querySelector('meta[name="quickstrip-token"]').content;

export async function post(form, data) {
  try {
    const response = await fetch(`/api/${form}`, {
      method: 'POST', headers: { 'Content-Type': 'application/json', 'X-Quickstrip-Token': token }, body: JSON.stringify(data),
    });
    const type = response.headers.get('Content-Type') ?? '';
    const answer = type.startsWith('application/json') ? await response.json() : { errors: [{ field: '', text: (await response.text()) || 'refused' }] };
    return { ok: response.ok, ...answer };
  } catch {
    return { ok: false, errors: [{ field: '', text: 'The display\'s program does not answer: nothing was sent.' }] };
  }
}
