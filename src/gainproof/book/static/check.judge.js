// A judge in a worker that is ended where a task takes too long, and what its tasks came to so far.
const MOST_MEMORY = 2 ** 30;
const PAUSE = 200;

export class Judge {
  // `make` returns a new worker.
  constructor(make) {
    this.make = make;
    this.worker = null;
    this.texts = {};
    this.settle = () => {};
  }

  end() {
    this.worker?.terminate();
    this.worker = null;
  }

  // What is asked comes to {stopped: true}.
  stop() {
    this.end();
    this.settle({ stopped: true });
  }

  // What the worker says to a request: {answer}, {failed} with what it complains of, {stopped}.
  async answer(request) {
    const lost = {};
    for (;;) {
      let texts = {};
      if (this.worker === null) {
        texts = this.texts;
        const begun = await this.begin();
        if (!begun.ready) {
          return begun;
        }
      }
      const said = await this.ask({ ...request, lost, texts });
      if (said.task === undefined) {
        return said;
      }
      lost[said.task] = said.why;
    }
  }

  begin() {
    const worker = this.make();
    this.worker = worker;
    return new Promise((settle) => {
      this.settle = settle;
      worker.onmessage = ({ data }) => settle(data);
      worker.onerror = (event) => settle({ failed: event.message || "it could not be loaded" });
    }).then((said) => {
      if (said.failed) {
        this.end();
      }
      return said;
    });
  }

  ask(request) {
    const worker = this.worker;
    let task;
    let timer;
    return new Promise((settle) => {
      const lose = (why) => {
        if (this.worker === worker) {
          this.end();
          settle(task === undefined ? { failed: why } : { task, why });
        }
      };
      this.settle = settle;
      // an error may overtake what was said before it
      worker.onerror = (event) => setTimeout(lose, PAUSE, event.message || "its process ended");
      worker.onmessage = ({ data }) => {
        clearTimeout(timer);
        if (data.begins) {
          task = data.begins;
          timer = setTimeout(lose, 1000 * data.seconds, "late");
        } else if (data.ends) {
          task = undefined;
          if (data.text !== null) {
            this.texts[data.ends] = data.text;
          }
        } else if (data.failed) {
          lose(data.failed);
        } else {
          if (data.memory > MOST_MEMORY) {
            this.end();
          }
          settle({ answer: data.answer });
        }
      };
      worker.postMessage(request);
    }).finally(() => clearTimeout(timer));
  }
}
